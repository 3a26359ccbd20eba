#!/usr/bin/env python3
"""The documentation as pages to be read in a browser: every Markdown file of the project, its links and pictures.

    make_pages.py SOURCE OUT

Writes OUT/<path>.html for each <path>.md and OUT/index.html, which leads to docs/README.html. A link to a file that is
not there, or to a heading that its page does not have, is an error: file:line, and exit code 1."""
import re
import shutil
import sys
from pathlib import Path

import markdown
from markdown.extensions.toc import slugify

FRAME = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} · wetfront</title><style>{style}</style></head>
<body class="text"><nav><a href="{up}docs/README.html">wetfront · documentation</a></nav>
<main>
{text}
</main></body></html>
"""
STYLE = """
main { max-width: 62rem; margin: 1rem auto 4rem; padding: 0 1.2rem; }
main img { max-width: 100%; background: #fff; }
main table { display: block; overflow-x: auto; border-collapse: collapse; margin: 1rem 0; }
main td, main th { padding: .3rem .7rem .3rem 0; border-bottom: 1px solid var(--rule); text-align: left; vertical-align: top; }
main code { color: inherit; font-family: var(--code); font-size: .88em; background: var(--wash); padding: 0 .2em; }
main pre code { padding: 0; font-size: 1em; }
"""
LINK = re.compile(r"(!?\[[^\]]*\]\()([^)\s]+)(\))")


def skipped(path, source):
    return any(part in ("build", "out") or part.startswith(".") for part in path.relative_to(source).parts)


def headings(text):
    plain = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    return {slugify(re.sub(r"[`*_]", "", title), "-") for title in re.findall(r"^#+ (.+)$", plain, flags=re.M)}


class Pages:
    def __init__(self, source, out):
        self.source, self.out, self.problems = source, out, []
        self.style = (source / "reports" / "page.css").read_text() + STYLE
        self.texts = {p: p.read_text() for p in sorted(source.rglob("*.md")) if not skipped(p, source)}

    def link(self, page, line, target):
        """Where a link of the page leads in OUT; pictures go along, other files are named as they lie in SOURCE."""
        if re.match(r"[a-z]+:", target):
            return target
        name, _, heading = target.partition("#")
        file = (page.parent / name).resolve() if name else page
        if file.is_dir() and file / "README.md" in self.texts:
            file, name = file / "README.md", name.rstrip("/") + "/README.md"
        if not file.exists():
            self.problems.append(f"{page.relative_to(self.source)}:{line}: '{target}' leads nowhere")
        if file in self.texts:
            if heading and heading not in headings(self.texts[file]):
                self.problems.append(f"{page.relative_to(self.source)}:{line}: '{name or page.name}' has no heading '#{heading}'")
            return re.sub(r"\.md$", ".html", name) + ("#" + heading if heading else "")
        if file.suffix in (".svg", ".png") and file.exists():
            copy = self.out / file.relative_to(self.source)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, copy)
            return target
        return file.as_uri()

    def write(self):
        for page, text in self.texts.items():
            lines = [LINK.sub(lambda m, n=n: m[1] + self.link(page, n, m[2]) + m[3], line)
                     for n, line in enumerate(text.split("\n"), 1)]
            place = self.out / page.relative_to(self.source).with_suffix(".html")
            place.parent.mkdir(parents=True, exist_ok=True)
            body = markdown.markdown("\n".join(lines), extensions=["tables", "fenced_code", "toc", "sane_lists"])
            title = next(iter(re.findall(r"^# (.+)$", text, flags=re.M)), page.stem)
            up = "../" * (len(place.relative_to(self.out).parts) - 1)
            place.write_text(FRAME.format(title=title.replace("`", ""), style=self.style, up=up, text=body))
        (self.out / "index.html").write_text('<meta http-equiv="refresh" content="0; url=docs/README.html">\n')


def main():
    pages = Pages(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve())
    pages.write()
    print("\n".join(pages.problems) or f"{len(pages.texts)} pages -> {pages.out / 'index.html'}")
    return 1 if pages.problems else 0


if __name__ == "__main__":
    sys.exit(main())
