"""The pictures of the book: each a function that draws on a given Matplotlib Axes.

One module per chapter: `cubic`, `mathieu`, `figure_eight`, `idea`. `style` is the house style. The
functions sample solutions of the package and of its references; they hold no mathematics.
"""
