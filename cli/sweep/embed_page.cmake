# Joins the files of the page into one C++ source.
# usage: cmake -DPAGE=page.html -DSTYLE=page.css "-DSCRIPTS=a.js;b.js" -DOUT=page_template.cpp -P embed_page.cmake
file(READ "${PAGE}" page)
file(READ "${STYLE}" style)
set(script "")
foreach(file IN LISTS SCRIPTS)
  file(READ "${file}" text)
  string(APPEND script "${text}")
endforeach()
string(REPLACE "{{style}}" "${style}" page "${page}")
string(REPLACE "{{script}}" "${script}" page "${page}")

file(WRITE "${OUT}" "// Written by embed_page.cmake.
#include \"cli/sweep/page.hpp\"

namespace orograph {

std::string_view sweep_page_template() {
  static constexpr std::string_view text =
      R\"page(${page})page\";
  return text;
}

} // namespace orograph
")
