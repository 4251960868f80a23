// SPDX-License-Identifier: GPL-2.0-or-later
// Prints the book, so that two processes can be compared.
#include <iostream>

#include "derivation/book.hpp"
#include "kernel/print.hpp"

int main() {
  for (const auto& chapter : derivation::the_book().chapters())
    for (const auto& s : chapter.statements)
      std::cout << s.id << " (" << s.label << ") " << s.words << " " << kernel::text(s.theorem)
                << "\n";
}
