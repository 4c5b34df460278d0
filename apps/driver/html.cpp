#include "html.hpp"

#include <fstream>
#include <sstream>

namespace sphonic::driver {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    return out;
}

std::string html_table(const std::vector<std::vector<std::string>>& rows) {
    std::string out = "<table>\n";
    for (std::size_t r = 0; r < rows.size(); ++r) {
        out += "<tr>";
        for (const std::string& cell : rows[r]) out += (r ? "<td>" : "<th>") + escaped(cell) + (r ? "</td>" : "</th>");
        out += "</tr>\n";
    }
    return out + "</table>\n";
}

std::string inline_svg(const std::filesystem::path& svg) {
    std::ifstream file(svg);
    std::ostringstream text;
    text << file.rdbuf();
    const std::string all = text.str();
    const auto begin = all.find("<svg");
    return begin == std::string::npos ? "" : all.substr(begin);
}

std::string html_page(const std::string& title, const std::string& body) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escaped(title) +
           "</title>\n<style>body{font:15px sans-serif;max-width:1100px;margin:2em auto;padding:0 1em}table{border-collapse:collapse;margin:1em 0}"
           "th,td{padding:3px 9px;border-bottom:1px solid #ccc;text-align:right}th:first-child,td:first-child{text-align:left}svg{max-width:100%;height:auto}</style></head><body>\n" +
           body + "</body></html>\n";
}

}    // namespace sphonic::driver
