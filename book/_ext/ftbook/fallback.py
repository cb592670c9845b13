"""A picture for readers without JavaScript: the one that an explorer brings with it.

An output that is a widget and a PNG image shows the widget in HTML; inside ``<noscript>`` it now
shows the image as well. Its alt text is the output's plain text, in HTML and in print.
"""

from docutils import nodes

WIDGET = "application/vnd.jupyter.widget-view+json"
IMAGE, TEXT = "image/png", "text/plain"


def add_pictures(app, document):
    """Handler of ``doctree-read``, before Sphinx collects the images."""
    for bundle in document.findall(nodes.container):
        if bundle.get("nb_element") == "mime_bundle":
            outputs = {part["mime_type"]: part for part in bundle.children}
            if WIDGET in outputs and IMAGE in outputs:
                _add_picture(outputs)


def _add_picture(outputs):
    for image in outputs[IMAGE].findall(nodes.image):
        if TEXT in outputs:
            image.setdefault("alt", outputs[TEXT].astext())
        outputs[WIDGET] += [
            nodes.raw("", "<noscript>", format="html"),
            image.deepcopy(),
            nodes.raw("", "</noscript>", format="html"),
        ]
