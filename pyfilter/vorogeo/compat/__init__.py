"""The functions of other packages, with their signatures and conventions: change one import."""
