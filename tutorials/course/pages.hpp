// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace magicmass::course {

/// A chapter's page, its body as HTML.
struct Page {
  std::string name;  // "05_counting"; the file is name.html
  std::string title;
  std::string body;
  int minutes = 0;
};

std::string chapter_page(const std::vector<Page>& pages, std::size_t number);
/// The first page: its own text, then the contents.
std::string index_page(const std::vector<Page>& pages, const std::string& body,
                       bool has_pdf);
/// All of it on one page, for paper.
std::string whole_page(const std::vector<Page>& pages, const std::string& body);

/// The page of all proofs with a way back to the course. Throws Refusal for a page without a header.
std::string proofs_page(std::string derivation);

/// Markdown as HTML, by pandoc; ids begin with the prefix. Throws Refusal.
std::string html_of(const std::string& markdown, const std::string& id_prefix);

}  // namespace magicmass::course
