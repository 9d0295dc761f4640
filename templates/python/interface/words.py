WORDS = {
    "pose tensor": "exp exp6 exp3 expm expmap matrix homogeneous",
    "from_pose from_tensor": "log log6 log3 logm logmap from_matrix",
    "quaternion": "quat",
    "from_quaternion": "from_quat",
    "to_exponential": "rotvec exp_coords",
    "from_exponential": "from_rotvec from_exp_coords",
    "inverse": "inv",
    "compose": "mul multiply product",
    "interpolate": "slerp sclerp lerp",
    "body_retract": "plus boxplus oplus rplus",
    "retract": "lplus",
    "body_local": "minus boxminus ominus rminus local_coordinates localcoordinates",
    "local": "lminus",
    "adjoint": "ad adj adjoint_map adjointmap action",
    "transform_point": "act apply transform_from transformfrom",
    "tangent": "jl ljac left_jacobian dexp",
    "body_tangent": "jr rjac right_jacobian jexp6 expmapderivative",
    "tangent_inv": "jlinv ljacinv left_jacobian_inverse dlog dexpinv dexp_inv",
    "body_tangent_inv": "jrinv rjacinv right_jacobian_inverse jlog jlog6 logmapderivative",
}
"""Functions, and words of other libraries for them in small letters. Of two functions, rotations have the latter."""

OF_WORD = {
    word: functions.split() for functions, words in WORDS.items() for word in (*words.split(), functions.split()[0])
}
