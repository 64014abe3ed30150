"""What pygeodesic's own tests import, answered by vorogeo."""

__version__ = "0"
