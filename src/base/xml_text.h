// Text inside XML, SVG and HTML.
#pragma once

#include <string>
#include <string_view>

namespace tetralux {

// Text that reads the same in an element or in an attribute in double quotes. Tabs and line ends are kept as numbers;
// XML has no way to write the other control characters, which become question marks.
std::string escapedXml(std::string_view text);

}  // namespace tetralux
