"""Exception of all validation."""


class ValidationFailed(Exception):
    """Error of an emitted kernel that differs from its formula or breaks its interface."""
