# The archive that ./dev release makes, and its checksum, which it prints.
vcpkg_download_distfile(archive
  URLS "${BENTUR_RELEASES}/bentur-${VERSION}.tar.gz"
  FILENAME "bentur-${VERSION}.tar.gz"
  SHA512 "${BENTUR_SHA512}")
vcpkg_extract_source_archive(source ARCHIVE "${archive}")
vcpkg_cmake_configure(SOURCE_PATH "${source}"
  OPTIONS -DBENTUR_BUILD_TESTS=OFF -DBENTUR_BUILD_BENCH=OFF -DBENTUR_HOUSE_CHECKS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/bentur)
vcpkg_copy_tools(TOOL_NAMES bentur AUTO_CLEAN)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${source}/LICENSE")
