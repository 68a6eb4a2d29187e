# The page of a run is the part of `report` that needs no NetCDF: for those who compile it without the rest. Each has a
# utf8.cpp of its own.
function(bentur_report_page_sources out)
  set(report ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
  file(GLOB sources CONFIGURE_DEPENDS ${report}/html/*.cpp ${report}/html/internal/*.cpp ${report}/scene/*.cpp)
  list(FILTER sources EXCLUDE REGEX "(_test|/report_figures|/sweep_report)\\.cpp$")
  set(${out} ${sources} ${report}/figures/style.cpp ${report}/story_text.cpp ${report}/words.cpp PARENT_SCOPE)
endfunction()

# Style, script and texts of the report become part of the program.
function(bentur_report_assets out)
  set(html ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/html)
  file(GLOB assets CONFIGURE_DEPENDS ${html}/*.css ${html}/*.js ${html}/*.toml)
  set(${out} ${assets} PARENT_SCOPE)
endfunction()
