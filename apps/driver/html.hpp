#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace sphonic::driver {

/// Text as HTML shows it.
std::string escaped(const std::string& text);

/// A table of text cells, the first row its head.
std::string html_table(const std::vector<std::vector<std::string>>& rows);

/// The drawing that stands in an SVG file, to be put into a page; empty if it was not drawn.
std::string inline_svg(const std::filesystem::path& svg);

/// A whole page without links outside.
std::string html_page(const std::string& title, const std::string& body);

}    // namespace sphonic::driver
