// SPDX-License-Identifier: GPL-2.0-or-later
// Texts, files and Markdown as parts of an HTML page.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace flowslide {

/// Text as HTML shows it: no character of it is taken for markup, in an element or in a quoted attribute.
std::string escaped(std::string_view text);

/// A file as a relative link from a page in `folder`, percent-encoded.
std::string link_from(const std::filesystem::path& folder, const std::filesystem::path& file);

/// A file as a "data:" URL, so that a page carries it along. Throws FileError when it cannot be read.
std::string data_url(const std::filesystem::path& file, std::string_view media_type);

/// Markdown as GitHub reads it (tables too), as HTML. Raw HTML in it is left out; links to files, which would lead
/// nowhere from another folder, become their text.
std::string html_of_markdown(const std::string& markdown);

/// Text of a Markdown file: that of its first heading; empty without one.
std::string first_heading(const std::string& markdown);
/// What stands under "## title" up to the next "## "; empty when there is none.
std::string section(const std::string& markdown, const std::string& title);

}  // namespace flowslide
