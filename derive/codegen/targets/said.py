"""The words in which the documentation of poses differs from that of rotations alone."""

from __future__ import annotations

from collections.abc import Mapping

POSES = {
    "motion": "displacement",
    "vectors": "Rodrigues dual vector",
    "quaternions": "unit dual quaternion",
    "twists": "twist",
    "wrench": "wrench",
    "real_first": "Dual tensor, real part first",
    "first": "[0]",
    "undecided": "takes the translation as axis of a pure translation and is NaN at the identity",
    "pairing": (
        "In components ``τ[3:]·v̇[:3] + τ[:3]·v̇[3:] = m·ω + f·v``, the power; with momenta [p, l] in place of [f, m], "
        "momenta of v."
    ),
}

ROTATIONS = {
    "motion": "rotation",
    "vectors": "Rodrigues vector",
    "quaternions": "unit quaternion",
    "twists": "angular velocity",
    "wrench": "moment",
    "real_first": "Matrix",
    "first": "",
    "undecided": "is NaN at the identity, which has no axis",
    "pairing": "That is the power; with an angular momentum in place of the moment, momenta of v.",
}

SAID: Mapping[str, Mapping[str, str]] = {"": POSES, "rotation": ROTATIONS}
"""By table."""
