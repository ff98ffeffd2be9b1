// SPDX-License-Identifier: GPL-2.0-or-later
// Texts, files and Markdown as parts of an HTML page.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace flowslide {

/// Text escaped for HTML, for use in an element or in a quoted attribute.
std::string escaped(std::string_view text);

/// Relative link, percent-encoded, to a file from a page in `folder`.
std::string link_from(const std::filesystem::path& folder, const std::filesystem::path& file);

/// The content of a file as a "data:" URL, which a page can contain. Throws FileError if the file cannot be read.
std::string data_url(const std::filesystem::path& file, std::string_view media_type);

/// HTML of GitHub's Markdown, tables included. Raw HTML is left out. Links to files become text, because they would not
/// work from another folder.
std::string html_of_markdown(const std::string& markdown);

/// The first heading of level 1 in a Markdown text; empty without one.
std::string first_heading(const std::string& markdown);
/// The text between "## title" and the next "## "; empty without this heading.
std::string section(const std::string& markdown, const std::string& title);

}  // namespace flowslide
