#include "bench/bench_page.h"

#include <gtest/gtest.h>

#include "bench/page_testing.h"
#include "bench/page_viewer.h"
#include "report/html_testing.h"

namespace drc {
namespace {

class BenchPageTest : public testing::Test {
  protected:
    std::string page() const { return benchPage(b.report, b.folder.path()); }
    // Something for every section.
    void addAll(const std::string& scene = "box") {
        for (const char* method : {"drc-maps", "path & <i>", "bdpt"})
            for (const double amount : {2., 8.}) b.add(scene, method, seconds(amount), 0.1 / amount);
        for (const double amount : {1., 16., 64.}) {
            b.add(scene, "drc-maps", tasks(amount), 0.1 / amount).seconds = amount;
            b.add(scene, "bdpt", spp(amount), 0.2 / amount).seconds = amount;
        }
    }

    ReportBuilder b;
};

constexpr const char* kSections[] = {"equal-time", "pictures", "tasks-and-samples", "curves", "memory",
                                     "figures",    "made"};

TEST_F(BenchPageTest, IsOneWellFormedFileThatFetchesNothing) {
    addAll();
    const std::string html = page();
    EXPECT_EQ(brokenNesting(html), "");
    for (const char* fetched :
         {"http:", "https:", "//www", "url(", "@import", "<link", "<iframe", "<script src", "import("})
        EXPECT_EQ(html.find(fetched), std::string::npos) << fetched;
    EXPECT_EQ(occurrences(html, " src="), 13 + 3);  // 12 pictures and the reference; three differences
    EXPECT_EQ(occurrences(html, " src="), occurrences(html, " src=\"data:image/png;base64,iVBORw0K"));
    EXPECT_EQ(occurrences(html, " href="), occurrences(html, " href=\"#"));
    for (const char* nan : {">nan", "nan<", "\"nan", " nan"}) EXPECT_EQ(html.find(nan), std::string::npos) << nan;
}

TEST_F(BenchPageTest, HasEverySectionInOrder) {
    addAll();
    const std::string html = page();
    size_t last = 0;
    for (const std::string id : kSections) {
        const size_t at = html.find("<section id=\"" + id + "\">");
        ASSERT_NE(at, std::string::npos) << id;
        EXPECT_GT(at, last) << id;
        EXPECT_EQ(occurrences(html, "href=\"#" + id + "\""), id == "figures" ? 2 : 1) << id;
        last = at;
    }
}

TEST_F(BenchPageTest, EscapesNames) {
    const std::string hostile = "<b>\"x\"</b>";
    addAll(hostile);
    b.addFailure(hostile, "it's </td>", seconds(2), "<script>no()</script> & \"so\"");
    b.report.processor = "<u>chip</u>";
    b.report.version = "1 & 2";
    b.report.scenes[0].file = "a<b>.pbrt";
    b.report.scenes[0].referenceOrigin = "<em>given</em>";
    const std::string html = page();
    EXPECT_EQ(brokenNesting(html), "");
    for (const char* raw : {"<b>\"x", "& <i>", "</td>s", "it's", "<script>no", "<u>", "a<b>", "<em>", "1 & 2"})
        EXPECT_EQ(html.find(raw), std::string::npos) << raw;
    for (const char* escaped : {"&lt;b&gt;&quot;x&quot;&lt;/b&gt;", "path &amp; &lt;i&gt;", "it&#39;s &lt;/td&gt;",
                                "&lt;script&gt;no()&lt;/script&gt; &amp; &quot;so&quot;", "&lt;u&gt;chip", "1 &amp; 2",
                                "a&lt;b&gt;.pbrt", "&lt;em&gt;given"})
        EXPECT_NE(html.find(escaped), std::string::npos) << escaped;
    EXPECT_EQ(occurrences(html, "<script>"), 1);
}

TEST_F(BenchPageTest, LeavesOutSectionsWithoutData) {
    b.add("box", "drc-maps", seconds(2), 0.1);
    const std::string html = page();
    for (const char* there : {"equal-time", "pictures", "made"})
        EXPECT_NE(html.find("<section id=\"" + std::string(there)), std::string::npos) << there;
    for (const char* missing : {"tasks-and-samples", "curves", "memory", "figures"})
        EXPECT_EQ(html.find("#" + std::string(missing)), std::string::npos) << missing;
    EXPECT_EQ(occurrences(html, "<section "), 3);
}

TEST_F(BenchPageTest, AllFailedHasNoPicturesAndNoScript) {
    b.addFailure("box", "drc-maps", seconds(2), "out of memory");
    const std::string html = page();
    EXPECT_EQ(brokenNesting(html), "");
    EXPECT_NE(html.find("out of memory"), std::string::npos);
    EXPECT_NE(html.find("of which 1 failed"), std::string::npos);
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_EQ(html.find("<img"), std::string::npos);
    EXPECT_EQ(occurrences(html, "<section "), 2);
}

TEST_F(BenchPageTest, NothingAtAllIsAPageToo) {
    const std::string html = page();
    EXPECT_EQ(brokenNesting(html), "");
    EXPECT_EQ(occurrences(html, "<section "), 1);
}

TEST_F(BenchPageTest, SaysHowItWasMade) {
    addAll();
    b.add("box", "drc-maps", seconds(2), 0.3);
    b.report.scenes[0].referenceOrigin = "path tracing, 60 s";
    const std::string html = page(), made = between(html, "<section id=\"made\"", "</section>");
    for (const char* part :
         {">drc 9.8.7<", ">some processor<", ">3<", ">2, 8 s; 1, 16, 64 spp; 1, 16, 64 tasks<", ">1 to 2<",
          ">one, path tracing, 60 s<", "<code>scene.pbrt</code>", ">16&#8201;&#215;&#8201;12<"})
        EXPECT_NE(made.find(part), std::string::npos) << part;
    EXPECT_NE(html.find("1&#160;scene, 3&#160;methods, 13&#160;runs. By drc 9.8.7 on some processor, 3&#160;threads."),
              std::string::npos);
}

// The script asks for what the page has, by the names that it has.
TEST_F(BenchPageTest, TheViewerOffersAllScenesMethodsAndBudgets) {
    addAll();
    b.add("hall", "drc-maps", seconds(2), 0.1);
    const std::string html = page(), choices = between(html, "<div class=\"viewer\"", "<div class=\"details\"");
    EXPECT_NE(choices.find("<option value=\"1\">hall</option>"), std::string::npos);
    EXPECT_EQ(occurrences(choices, "<option value=\"1\">path &amp; &lt;i&gt;</option>"), 2);
    EXPECT_EQ(occurrences(choices, "<option value=\"reference\">reference</option>"), 2);
    EXPECT_EQ(occurrences(choices, "<option value=\"1\">8 s</option>"), 2);
    EXPECT_NE(choices.find("type=\"range\""), std::string::npos);
    // Only a script shows it, and only a script hides the rest of the pictures.
    EXPECT_NE(choices.find("<div class=\"viewer\" hidden=\"hidden\">"), std::string::npos);
    EXPECT_NE(html.find("<details class=\"all\" open=\"open\">"), std::string::npos);
    EXPECT_EQ(occurrences(viewerScript(), "<"), 2);  // its own tags
}

}  // namespace
}  // namespace drc
