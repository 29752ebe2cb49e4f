"""The site that ./dev docs makes by Sphinx: docs/, the README, examples/notebooks and the docstrings of the Python package.

The source directory is the root of the project, so that links in its pages are right as they stand.
"""

import re
from pathlib import Path

import phrame
from sphinx.util import logging

ROOT = Path(__file__).parents[2]

project = "phrame"
release = re.search(r"project\(phrame VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
root_doc = "docs/site/index"
include_patterns = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "docs/*.md", "docs/site/*.md", "examples/notebooks/*.ipynb"]
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.mathjax"]

html_theme = "furo"
html_title = f"phrame {release}"
html_copy_source = False
html_static_path = ["../../build/docs/formulas"]

# Formulas are set by KaTeX, as on the pages of phrame, and not by what a server far away sends.
html_assets_policy = "always"
mathjax_path = "formulas.js"
mathjax_options = {"defer": "defer"}
if (ROOT / "build/docs/formulas/katex.min.js").exists():
    html_css_files = ["katex.min.css"]
    html_js_files = ["katex.min.js"]

myst_heading_anchors = 3
myst_enable_extensions = ["dollarmath"]
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 120
nb_execution_show_tb = True

autodoc_typehints = "signature"
autoclass_content = "both"


def without_folders(app, document, source):
    """Links to folders, which are none on a site, as plain text."""
    page = Path(app.srcdir, document).parent

    def as_text(link):
        return link[1] if (page / link[2]).is_dir() else link[0]

    source[0] = re.sub(r"\[([^\]]+)\]\(([^)#:]+)\)", as_text, source[0])


def as_plain_text(_app, what, name, _thing, _options, lines):
    """Docstrings are English, not reStructuredText: stars and bars are themselves, and `x` is code."""
    if what != "module" and not any(line.strip() and not re.match(r"\(self.*\) -> ", line) for line in lines):
        logging.getLogger(__name__).warning("%s has no docstring", name)
    for k, line in enumerate(lines):
        if line.lstrip().startswith(">>>"):
            break  # an example, to the end
        parts = re.split(r"(`[^`]+`)", line)
        lines[k] = "".join(f"`{part}`" if n % 2 else re.sub(r"([*|\\]|_\b)", r"\\\1", part) for n, part in enumerate(parts))


def as_functions(types):
    """The static methods of the module in C++, which autodoc takes for values, as functions of Python."""
    for type_ in types:
        for name, method in list(vars(type_).items()):
            if type(method).__name__ == "nb_func":

                def function(*args, method=method, **options):
                    return method(*args, **options)

                function.__name__, function.__doc__ = name, method.__doc__
                setattr(type_, name, staticmethod(function))


def with_first_page(app, failure):
    if not failure:
        Path(app.outdir, "index.html").write_text(f'<meta http-equiv="refresh" content="0; url={root_doc}.html">\n')


def setup(app):
    as_functions([phrame.Path, phrame.Certificate])
    app.connect("source-read", without_folders)
    app.connect("autodoc-process-docstring", as_plain_text)
    app.connect("build-finished", with_first_page)
