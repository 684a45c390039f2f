#include "report/html_page.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/html_testing.h"

namespace drc {
namespace {

TEST(HtmlPage, EscapesWhatMeansSomething) {
    EXPECT_EQ(escapeHtml("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
    EXPECT_EQ(escapeHtml("\u00e9\u2013"), "\u00e9\u2013");
}

TEST(HtmlPage, Base64AgreesWithRfc4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(HtmlPage, PicturesArePngs) {
    // Begins with the base64 encoding of the first six bytes of the PNG signature.
    EXPECT_EQ(pngDataUri(Image(2, 2)).substr(0, 30), "data:image/png;base64,iVBORw0K");
}

TEST(HtmlPage, IsOneWellFormedFile) {
    const std::string page = htmlPage("a < b", "<p>text<br/></p>\n");
    EXPECT_EQ(brokenNesting(page), "");
    EXPECT_NE(page.find("<title>a &lt; b</title>"), std::string::npos);
    EXPECT_NE(page.find("<p>text<br/></p>"), std::string::npos);
    EXPECT_NE(brokenNesting(htmlPage("", "<p><b>text</p></b>")), "");
    EXPECT_NE(brokenNesting(htmlPage("", "<p>text")), "");
    for (const char* fetched : {"http", "url(", "@import", "<link", "<script", "src="})
        EXPECT_EQ(page.find(fetched), std::string::npos) << fetched;
}

TEST(HtmlPage, PValuesKeepTwoDigits) {
    EXPECT_EQ(htmlP(1), "1.0");
    EXPECT_EQ(htmlP(0.5), "0.50");
    EXPECT_EQ(htmlP(0.0409), "0.041");
    EXPECT_EQ(htmlP(1.33e-82), "1.3&#8201;&#215;&#8201;10<sup>&#8722;82</sup>");
    EXPECT_EQ(htmlP(9.96e-5), "1.0&#8201;&#215;&#8201;10<sup>&#8722;4</sup>");
    EXPECT_EQ(htmlP(0), "&lt;&#8201;10<sup>&#8722;300</sup>");
    EXPECT_EQ(htmlP(NAN), "&#8211;");
}

TEST(HtmlPage, ThreeDigitsCount) {
    EXPECT_EQ(htmlSignificant(0), "0");
    EXPECT_EQ(htmlSignificant(0.00123456), "0.00123");
    EXPECT_EQ(htmlSignificant(0.5), "0.500");
    EXPECT_EQ(htmlSignificant(9.996), "10.0");
    EXPECT_EQ(htmlSignificant(-12.34), "-12.3");
    EXPECT_EQ(htmlSignificant(123.4), "123");
    EXPECT_EQ(htmlSignificant(12345), "12345");
    EXPECT_EQ(htmlSignificant(0.000123456), "0.000123");
    EXPECT_EQ(htmlSignificant(0.0000123456), "1.23&#8201;&#215;&#8201;10<sup>&#8722;5</sup>");
    EXPECT_EQ(htmlSignificant(2.5e7), "2.50&#8201;&#215;&#8201;10<sup>7</sup>");
    EXPECT_EQ(htmlSignificant(INFINITY), "&#8734;");
    EXPECT_EQ(htmlSignificant(NAN), "&#8211;");
}

TEST(HtmlPage, StyleOfAPageFollowsThatOfAll) {
    const std::string page = htmlPage("", "", ".mine { color: red; }");
    EXPECT_LT(page.find(":root"), page.find(".mine { color: red; }"));
    EXPECT_LT(page.find(".mine"), page.find("</style>"));
    EXPECT_EQ(brokenNesting(page), "");
}

}  // namespace
}  // namespace drc
