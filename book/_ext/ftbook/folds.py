"""What the button of a folded cell says: whether code or a check is behind it.

A cell with the tag ``hide-input`` shows its result and folds its code; one with ``hide-cell`` folds
both, because it only checks what the text says. A notebook may give a cell a text of its own with
``mystnb: {code_prompt_show: …}``.
"""

from docutils import nodes

WORDS = {"input": "the code", "all": "the check"}
#: the label of every button, whatever it shows: who hears the page needs the words on it
LABEL = ' aria-label="Toggle hidden content"'


def name_buttons(app, document):
    """Handler of ``doctree-read``."""
    for cell in document.findall(nodes.container):
        words = WORDS.get(cell.get("hide_mode"))
        own = cell.get("cell_metadata", {}).get("mystnb", {})
        if words and "code_prompt_show" not in own:
            cell["prompt_show"], cell["prompt_hide"] = f"Show {words}", f"Hide {words}"


def say_what_is_shown(app, pagename, templatename, context, doctree):
    """Handler of ``html-page-context``: a button is called what it shows."""
    if "body" in context:
        context["body"] = context["body"].replace(f"<summary{LABEL}>", "<summary>")
