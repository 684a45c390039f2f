// Opens an address in the desktop's browser.
#pragma once
#include <string>

namespace drc {

// Lets xdg-open open a page that leads to the address and that only this user can read: all users of the machine can
// read command lines, and the address contains a token. Returns at once; the page is removed after a minute. Throws
// Error if there is no xdg-open, or the page cannot be written. address: only letters, digits and -._~:/[].
void openInBrowser(const std::string& address);

}  // namespace drc
