"""The errors of the package; every message names the offending element and says what to do."""


class Error(Exception):
    """Base of every error that vorogeo raises on purpose."""


class InvalidInput(Error, ValueError):
    """An argument or a mesh that cannot be used."""


class FileError(Error, OSError):
    """A file that cannot be read or written: missing, damaged, no permission, a full disk."""


class IndexFileError(FileError):
    """An index file that cannot be written; or one that is missing, truncated, damaged, of another version or mesh."""


class Cancelled(Error):
    """The progress function asked to stop; nothing was changed."""


class NotEnoughMemory(Error, MemoryError):
    """A result that needs more memory than there is; raised before it is allocated."""


class PluginError(Error, RuntimeError):
    """The filters cannot be added to the installed PyMeshLab."""
