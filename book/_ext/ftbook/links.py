"""Launch buttons and repository links, from the repository's address at build time.

The address is the environment variable FTSERIES_REPOSITORY or else the git remote ``origin``.
Where neither names a repository on a host that readers can open, the buttons are absent.
"""

import os
import re
import subprocess

BRANCH = "main"
COLAB = "https://colab.research.google.com"
HOSTS = ("github.com", "gitlab.com")
_ADDRESS = re.compile(
    r"(?:(?:https?|ssh|git)://)?(?:[^/@]+@)?(?P<host>[^/:@]+)(?::\d+(?=/))?[/:]"
    r"(?P<path>[\w.-]+(?:/[\w.-]+)+)"
)


def public_address(remote):
    """Address of a repository that a reader can open, or None.

    >>> public_address("git@github.com:someone/ftseries.git")
    'https://github.com/someone/ftseries'
    >>> public_address("/srv/git/ftseries.git") is None
    True
    """
    match = _ADDRESS.fullmatch(remote.strip().rstrip("/").removesuffix(".git"))
    if match is None or match["host"].lower() not in HOSTS:
        return None
    return f"https://{match['host'].lower()}/{match['path']}"


def find_repository(folder):
    """Public address of the repository in ``folder``, or None."""
    if "FTSERIES_REPOSITORY" in os.environ:
        return public_address(os.environ["FTSERIES_REPOSITORY"])
    try:
        remote = subprocess.run(
            ["git", "-C", folder, "remote", "get-url", "origin"],
            capture_output=True, text=True, check=True,
        )  # fmt: skip
    except (OSError, subprocess.CalledProcessError):
        return None
    return public_address(remote.stdout)


def add_repository(app, config):
    """Give the theme the repository's address, if there is one."""
    address = find_repository(str(app.srcdir))
    if address is None:
        return
    config.html_theme_options.update(
        repository_url=address,
        repository_branch=BRANCH,
        use_repository_button=True,
        use_issues_button=True,
        launch_buttons={
            "notebook_interface": "jupyterlab",
            "binderhub_url": "https://mybinder.org",
            # Colab opens notebooks of GitHub only, and the theme warns of others.
            "colab_url": COLAB if address.startswith("https://github.com/") else "",
        },
    )
