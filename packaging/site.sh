#!/usr/bin/env bash
# site.sh OUT: docs/*.md and README.md as pages that open from a file system, by cmark-gfm or cmark, with their pictures.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$1
cmark=$(command -v cmark-gfm || true)
[ -n "$cmark" ] || { echo "crest: the site needs Debian's package cmark-gfm" >&2; exit 1; }

# page FILE TITLE TOP: a page of FILE, whose links to .md go to pages; TOP leads to the site's folder. Headings get the names
# that links to them have, as GitHub makes these.
page() {
  cat <<HTML
<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>$2</title>
<link rel="stylesheet" href="$3site.css">
<nav><a href="$3index.html">Crest</a> <a href="$3docs/manual/index.html">Manual</a> <a href="$3docs/manual/options.html">Options</a>
<a href="$3docs/manual/scripts.html">Scripts</a> <a href="$3docs/architecture.html">Architecture</a>
<a href="$3docs/measured.html">Measured</a> <a href="$3CHANGELOG.html">Changes</a></nav>
<main>
HTML
  "$cmark" -e table -e autolink "$1" |
    sed -E 's,(href="[^":]*)README\.md,\1index.html,g; s,(href="[^":]*)\.md(["#]),\1.html\2,g' |
    awk 'match($0, /^<h[1-6]>/) {
           name = tolower($0); gsub(/<[^>]*>/, "", name); gsub(/&[a-z]+;/, "", name)
           gsub(/[^a-z0-9 _-]/, "", name); gsub(/ /, "-", name)
           sub(/^<h[1-6]/, "& id=\"" name "\"")
         } { print }'
  echo "</main></html>"
}

rm -rf "$out"
mkdir -p "$out"
cp "$root/packaging/site.css" "$out/"
(cd "$root" && git ls-files -co --exclude-standard README.md CHANGELOG.md CONTRIBUTING.md CITATION.cff LICENSE docs) |
  while read -r file; do
    mkdir -p "$out/$(dirname "$file")"
    case $file in
      *.md)
        html=${file%.md}.html
        [ "$file" = README.md ] && html=index.html
        top=$(dirname "$file" | sed -E 's,^\.$,,; s,[^/]+/?,../,g')
        title=$(sed -n 's/^# *//p;/^# /q' "$root/$file")
        page "$root/$file" "$title" "$top" >"$out/$html"
        ;;
      *) cp "$root/$file" "$out/$file" ;;
    esac
  done
