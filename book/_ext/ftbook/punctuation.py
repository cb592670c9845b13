"""A formula in a sentence keeps the sign that follows it: no line begins with a comma.

A browser may break a line after any inline formula, since it is a picture to it.
"""

from docutils import nodes

SIGNS = tuple(",.;:!?)’”")


def glue(app, doctree, docname):
    """Handler of ``doctree-resolved``: formula and sign together, in a span that does not break."""
    if app.builder.format != "html":
        return
    for formula in list(doctree.findall(nodes.math)):
        after = formula.next_node(descend=False, siblings=True)
        if not isinstance(after, nodes.Text) or not after.startswith(SIGNS):
            continue
        sign = after[:len(after) - len(after.lstrip("".join(SIGNS)))]
        parent, place = formula.parent, formula.parent.index(formula)
        parent[place + 1] = nodes.Text(after[len(sign):])
        parent[place] = nodes.inline("", "", formula, nodes.Text(sign), classes=["ft-glued"])
