# What of `report` needs neither NetCDF nor other programs: figures and the page of a run, for those who compile it
# without the rest.
function(bentur_report_page_sources out)
  set(report ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  file(GLOB sources CONFIGURE_DEPENDS ${report}/*.cpp ${report}/figures/*.cpp ${report}/figures/internal/*.cpp
    ${report}/kinds/*.cpp ${report}/kinds/internal/*.cpp ${report}/kinds/plan/*.cpp ${report}/scene/*.cpp ${report}/html/*.cpp ${report}/html/plan/*.cpp ${report}/html/internal/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  set(${out} ${sources} PARENT_SCOPE)
endfunction()

# Style, script and texts of the report become part of the program.
function(bentur_report_assets out)
  set(html ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/html)
  file(GLOB assets CONFIGURE_DEPENDS ${html}/*.css ${html}/*.js ${html}/motion/*.js ${html}/*.toml)
  set(${out} ${assets} PARENT_SCOPE)
endfunction()
