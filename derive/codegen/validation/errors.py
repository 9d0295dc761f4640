"""The exception of all validation."""


class ValidationFailed(Exception):
    """An emitted kernel does not compute its formula, or does not keep what its interface promises."""
