/// The reader of references.bib, and the citations in a text.
#include "verification/catalogue/bibliography.hpp"

#include <boost/test/unit_test.hpp>

#include "solver/base/error.hpp"

BOOST_AUTO_TEST_SUITE(bibliography_tests)

using namespace talus::verification;

namespace {

Bibliography read(const std::string& text) { return parse_bibliography(text, "r.bib"); }

/// Error message of the reader for a text.
std::string error_message(const std::string& text) {
  try {
    static_cast<void>(read(text));
  } catch (const talus::InputError& error) {
    return error.what();
  }
  return "none";
}

/// An article whose sixth line is `line`.
std::string article(const std::string& line, const std::string& key = "hertz1882") {
  return "@article{" + key +
         ",\n  author = {Hertz, H.},\n  title = {{Über}},\n  journal = {Journal},\n  year = 1882,\n" + line + "\n}\n";
}

/// An entry without authors.
std::string entry(const std::string& start, const std::string& fields = "") {
  return start + ",\n title = {{T}},\n" + fields + "}\n";
}

}  // namespace

BOOST_AUTO_TEST_CASE(entries_fields_and_strings_are_read) {
  const std::string text =
      "% A comment, with { and =\n@string{unseen = {Not at hand.}}\n\n@book{galilei1638,\n author = {Galilei, G.},\n "
      "title = {{Discorsi e {dimostrazioni}}},\nyear = {1638},\n note = unseen,\n}\n" +
      article("  url = {https://a.org/~b#c},");
  const Bibliography bibliography = read(text);
  BOOST_TEST(bibliography.text == text);
  BOOST_TEST_REQUIRE(bibliography.works.size() == 2u);
  const Reference& book = bibliography.works[0];
  BOOST_TEST(book.key == "galilei1638");
  BOOST_TEST(book.type == "book");
  BOOST_TEST(book.fields.size() == 4u);
  BOOST_TEST(book.field("title") == "{Discorsi e {dimostrazioni}}");
  BOOST_TEST(book.field("year") == "1638");
  BOOST_TEST(book.field("note") == "Not at hand.");
  BOOST_TEST(book.field("pages") == "");
  BOOST_TEST(bibliography.works[1].field("url") == "https://a.org/~b#c");
  BOOST_TEST(bibliography.has("hertz1882"));
  BOOST_TEST(!bibliography.has("hertz"));
  BOOST_TEST(read("").works.empty());
  // An editor may replace the author; the key of a work without year has none.
  BOOST_TEST(error_message(entry("@book{ed1964", " editor = {Ed, A.},\n year = 1964,\n")) == "none");
  BOOST_TEST(error_message(entry("@misc{web")) == "none");
}

BOOST_AUTO_TEST_CASE(lines_of_another_form_are_refused) {
  const std::string outside = "; it must be `@type{key,`, `@string{name = {text}}` or a comment after %";
  const std::string inside = "; it must be `name = {text},`, `name = number,`, `name = string,` or `}`";
  BOOST_TEST(error_message("\n\nx") == "r.bib:3: found \"x\"" + outside);
  BOOST_TEST(error_message("@misc{A,") == "r.bib:1: found \"@misc{A,\"" + outside);
  BOOST_TEST(error_message("@string{a = b}") == "r.bib:1: found \"@string{a = b}\"" + outside);
  BOOST_TEST(error_message("% of @article") == "r.bib:1: found @ in a comment; BibTeX takes it for an entry");
  for (const char* line : {" title {T},", " title = \"T\",", " title = {T}", " title = {T", "} ", "@misc{b,"})
    BOOST_TEST(error_message("@misc{a,\n" + std::string{line}) ==
               "r.bib:2: a: found \"" + std::string{line} + "\"" + inside);
  BOOST_TEST(error_message("@misc{a,\n note = {a}b},") == "r.bib:2: a: found \"{a}b}\"; its braces do not match");
  BOOST_TEST(error_message("@misc{a,\n note = {a{b},") == "r.bib:2: a: found \"{a{b}\"; its braces do not match");
  BOOST_TEST(error_message("@misc{a,\n title = {{T}},\n") ==
             "r.bib:3: a: the end of the file; the entry must end with a line }");
  BOOST_TEST(error_message("@string{a = {x}}\n@string{a = {y}}") == "r.bib:2: string 'a' is given twice");
  BOOST_TEST(error_message("% \xff") == "r.bib:1: the line is not UTF-8");
}

BOOST_AUTO_TEST_CASE(unknown_names_are_refused_with_the_nearest) {
  BOOST_TEST(error_message(entry("@artikle{a1"))
                 .starts_with("r.bib:1: type 'artikle' is not known; nearest: article; "
                              "known: article, book,"));
  BOOST_TEST(error_message(article("  jurnal = {J},"))
                 .starts_with("r.bib:6: hertz1882: field 'jurnal' is not known; nearest: journal; known: address,"));
  BOOST_TEST(error_message("@string{unseen = {x}}\n" + entry("@misc{a", " note = useen,\n")) ==
             "r.bib:4: a: string 'useen' is not known; nearest: unseen; known: unseen");
}

BOOST_AUTO_TEST_CASE(wrong_missing_and_repeated_fields_are_refused) {
  BOOST_TEST(error_message(entry("@article{h1882", " author = {H},\n year = 1882,\n")) ==
             "r.bib:5: h1882: journal: it is missing; @article requires it");
  BOOST_TEST(error_message(entry("@book{h1882", " year = 1882,\n")) ==
             "r.bib:4: h1882: author: it is missing; @book requires it");
  BOOST_TEST(error_message(article("  year = 1882,")) == "r.bib:6: hertz1882: year: it is given twice");
  BOOST_TEST(error_message(article("  note = { },")) == "r.bib:6: hertz1882: note: found \" \"; it must not be empty");
  BOOST_TEST(error_message(article("  note = {A \\& B},")) ==
             "r.bib:6: hertz1882: note: found \"A \\& B\"; it must be in UTF-8 without LaTeX's commands and special "
             "characters \\ $ % # & ~ ^");
  const std::string rule = "; it must be in two pairs of braces, {{..}}, which preserve its capitals";
  BOOST_TEST(error_message(article("  publisher = {Wiley and Sons},")) ==
             "r.bib:6: hertz1882: publisher: found \"Wiley and Sons\"" + rule);
  BOOST_TEST(error_message(article("  series = {{A} and {B}},")) ==
             "r.bib:6: hertz1882: series: found \"{A} and {B}\"" + rule);
}

BOOST_AUTO_TEST_CASE(keys_are_in_order_and_end_with_their_year) {
  const std::string rule = "found after hertz1882; keys must be sorted and unique";
  BOOST_TEST(error_message(article("") + article("", "antypov1882")) == "r.bib:8: antypov1882: " + rule);
  BOOST_TEST(error_message(article("") + article("")) == "r.bib:8: hertz1882: " + rule);
  for (const char* key : {"hertz1881", "hertz"})
    BOOST_TEST(error_message(article("", key)) ==
               "r.bib:7: " + std::string{key} + ": year: found \"1882\"; the key must be a name and the year");
}

BOOST_AUTO_TEST_CASE(what_is_cited_is_found_and_what_lacks_an_entry_is_named) {
  const auto work = [](const std::string& name, const std::string& year) {
    return entry("@misc{" + name + year, " year = " + year + ",\n");
  };
  const Bibliography works =
      read(work("bartz", "2022") + work("hertz", "1882") + work("tsuji", "1992") + work("walton", "1986"));
  const Citations all = citations_in(
      "Hertz, J. reine angew. Math. 92 (1882) 156; Tsuji, Tanaka & Ishida, Powder Technol. 71 (1992) 239; Walton & "
      "Braun 1986, Eq. 1; derived here; arXiv 2204.10917",
      works);
  BOOST_TEST(all.missing.empty());
  BOOST_TEST((all.keys == std::vector<std::string>{"hertz1882", "tsuji1992", "walton1986"}));
  const Citations some = citations_in("Hertz 1882; Nobody & Noone 1993, section 5; of 1882", works);
  BOOST_TEST((some.keys == std::vector<std::string>{"hertz1882"}));
  BOOST_TEST_REQUIRE(some.missing.size() == 2u);  // a name before a semicolon is not combined with a year after it
  BOOST_TEST(some.missing[0] == "nobody 1993");
  BOOST_TEST(some.missing[1] == "1882");
}

BOOST_AUTO_TEST_SUITE_END()
