// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/markup.hpp"

#include <cmark-gfm-core-extensions.h>
#include <fmt/format.h>

#include <cctype>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/base64.hpp"

namespace flowslide {
namespace {

/// Replaces each link to a file by its text.
void unlink_files(cmark_node* document) {
  std::vector<cmark_node*> links;
  const std::unique_ptr<cmark_iter, void (*)(cmark_iter*)> nodes(cmark_iter_new(document), cmark_iter_free);
  while (cmark_iter_next(nodes.get()) != CMARK_EVENT_DONE) {
    cmark_node* node = cmark_iter_get_node(nodes.get());
    if (cmark_node_get_type(node) == CMARK_NODE_LINK &&
        std::string_view(cmark_node_get_url(node)).find("://") == std::string_view::npos &&
        (links.empty() || links.back() != node))
      links.push_back(node);
  }
  for (cmark_node* link : links) {
    while (cmark_node* child = cmark_node_first_child(link)) cmark_node_insert_before(link, child);
    cmark_node_free(link);
  }
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&': html += "&amp;"; break;
      case '<': html += "&lt;"; break;
      case '>': html += "&gt;"; break;
      case '"': html += "&quot;"; break;
      default: html += c;
    }
  }
  return html;
}

std::string link_from(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const std::string path = std::filesystem::proximate(file, folder).generic_string();
  std::string link;
  for (const char c : path) {
    const bool plain =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("-._~/").find(c) != std::string_view::npos;
    link += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return link;
}

std::string data_url(const std::filesystem::path& file, std::string_view media_type) {
  return fmt::format("data:{};base64,{}", media_type, base64(read_file(file)));
}

std::string html_of_markdown(const std::string& markdown) {
  cmark_gfm_core_extensions_ensure_registered();
  const std::unique_ptr<cmark_parser, void (*)(cmark_parser*)> parser(cmark_parser_new(CMARK_OPT_DEFAULT),
                                                                      cmark_parser_free);
  cmark_parser_attach_syntax_extension(parser.get(), cmark_find_syntax_extension("table"));
  cmark_parser_feed(parser.get(), markdown.data(), markdown.size());
  const std::unique_ptr<cmark_node, void (*)(cmark_node*)> document(cmark_parser_finish(parser.get()), cmark_node_free);
  unlink_files(document.get());
  const std::unique_ptr<char, void (*)(void*)> html(
      cmark_render_html(document.get(), CMARK_OPT_DEFAULT, cmark_parser_get_syntax_extensions(parser.get())),
      std::free);
  return html.get();
}

std::string first_heading(const std::string& markdown) {
  std::istringstream lines(markdown);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("# ")) return line.substr(2);
  return "";
}

std::string section(const std::string& markdown, const std::string& title) {
  std::istringstream lines(markdown);
  std::string text;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## ")) inside = line == "## " + title;
    else if (inside) text += line + "\n";
  }
  return text;
}

}  // namespace flowslide
