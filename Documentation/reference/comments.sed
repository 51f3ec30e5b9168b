# Doxygen's filter for the C headers, whose comments are plain: // before a declaration, and behind a member.
1s|^// SPDX.*|/// \\file|
s|^( *)// |\1/// |
s|^( *)//$|\1///|
s|([;,{]) +// |\1 ///< |
s|^( *[A-Za-z_][A-Za-z_0-9]*( = [^/]*)?) +// |\1 ///< |
s|^/\* |/** |
s|([;,{]) +/\* |\1 /**< |
