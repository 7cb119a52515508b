# Writes hash_of_sources.cpp, with a hash of the sources that sources.txt lists: of their names in
# FOLDER and their texts.
file(STRINGS sources.txt sources)
foreach(source IN LISTS sources)
  file(SHA256 "${source}" hash)
  file(RELATIVE_PATH name "${FOLDER}" "${source}")
  string(APPEND hashes "${hash} ${name}\n")
endforeach()
string(SHA256 hash "${hashes}")
file(WRITE hash_of_sources.cpp "namespace l0_tool {
extern const char* const hash_of_sources;
const char* const hash_of_sources = \"${hash}\";
} // namespace l0_tool
")
