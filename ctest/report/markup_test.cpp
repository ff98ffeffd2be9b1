// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/markup.hpp"

#include <gmock/gmock.h>

#include "record/atomic_file.hpp"
#include "record/temporary_folder.hpp"

namespace flowslide {
namespace {

TEST(Escaped, LeavesNoMarkup) { EXPECT_EQ(escaped("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d"); }

TEST(LinkFrom, IsRelativeAndEncoded) {
  EXPECT_EQ(link_from("/a/results", "/a/results/fig 3/e0_790.h5"), "fig%203/e0_790.h5");
  EXPECT_EQ(link_from("/a/pages", "/a/results/x#1.h5"), "../results/x%231.h5");
}

TEST(DataUrl, CarriesTheFile) {
  const TemporaryFolder folder;
  write_atomically(folder / "a", "Man");
  EXPECT_EQ(data_url(folder / "a", "image/png"), "data:image/png;base64,TWFu");
  EXPECT_THROW(data_url(folder / "b", "image/png"), FileError);
}

TEST(HtmlOfMarkdown, KnowsTables) {
  const std::string html = html_of_markdown("| N | error |\n|---|---|\n| 8 | `0.5` |\n");
  EXPECT_THAT(html, testing::HasSubstr("<th>error</th>"));
  EXPECT_THAT(html, testing::HasSubstr("<td><code>0.5</code></td>"));
}

TEST(HtmlOfMarkdown, KeepsLinksToThePageOnlyWhereTheyLead) {
  EXPECT_EQ(html_of_markdown("See [Fig. *12*](../x.md), [this](https://example.org/)."),
            "<p>See Fig. <em>12</em>, <a href=\"https://example.org/\">this</a>.</p>\n");
}

TEST(HtmlOfMarkdown, LetsNoScriptThrough) {
  EXPECT_THAT(html_of_markdown("a <script>alert(1)</script>\n\n<b onclick=\"x\">c</b>\n"),
              testing::AllOf(testing::Not(testing::HasSubstr("<script")), testing::Not(testing::HasSubstr("<b "))));
}

TEST(Markdown, IsTakenApart) {
  const std::string text = "# Title\n\n## One\n\na\n### deeper\nb\n## Two\nc\n";
  EXPECT_EQ(first_heading(text), "Title");
  EXPECT_EQ(first_heading("no heading"), "");
  EXPECT_EQ(section(text, "One"), "\na\n### deeper\nb\n");
  EXPECT_EQ(section(text, "Three"), "");
}

}  // namespace
}  // namespace flowslide
