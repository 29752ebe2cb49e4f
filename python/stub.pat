# What the signatures in src/ name without a module.
_phrame.__prefix__:
    import collections.abc
    import decimal
    import fractions
    import os
    import typing
    import numpy
    import numpy.typing
    import phrame._offsets
    from phrame._types import Number, Numbers, Vector, Vectors


# What phrame._signatures adds.
__signature__:
