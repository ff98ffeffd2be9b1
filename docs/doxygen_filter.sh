#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# doxygen_filter.sh FILE: prints it for doxygen. In the comments of a header, <name> becomes &lt;name&gt;; in a page, links
# to other files become their text.
case $1 in
  *.md) sed -E 's/\[([^]]*)\]\([^)h#][^)]*\)/\1/g' "$1" ;;
  *) sed -E -e ':again' -e 's/(\/\/\/.*)<([A-Za-z_][A-Za-z_0-9]*)>/\1\&lt;\2\&gt;/' -e 't again' "$1" ;;
esac
