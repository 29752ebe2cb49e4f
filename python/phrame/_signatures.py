"""What inspect.signature() says of the functions of the extension: what the stub says of them."""

from __future__ import annotations

import ast
import gc
from inspect import Parameter, Signature
from typing import Any, Dict, List, Optional, Sequence

from . import _phrame


def _definitions(function: Any) -> List[ast.FunctionDef]:
    """Of all overloads."""
    texts = [signature[0] for signature in function.__nb_signature__]
    trees = [ast.parse(text if text.endswith("...") else text + ": ...") for text in texts]
    return [node for tree in trees for node in tree.body if isinstance(node, ast.FunctionDef)]


def _any_of(annotations: Sequence[Optional[ast.expr]]) -> Any:
    names = [ast.unparse(annotation) for annotation in annotations if annotation is not None]
    return " | ".join(dict.fromkeys(names)) or Parameter.empty


def _parameters(definition: ast.FunctionDef) -> List[Parameter]:
    a = definition.args
    found: List[Parameter] = []

    def add(kind: Any, arguments: Sequence[ast.arg], defaults: Sequence[Optional[ast.expr]]) -> None:
        for argument, default in zip(arguments, defaults):
            value = Parameter.empty if default is None else ast.literal_eval(default)
            found.append(Parameter(argument.arg, kind, default=value, annotation=_any_of([argument.annotation])))

    missing: List[Optional[ast.expr]] = [None] * (len(a.posonlyargs) + len(a.args) - len(a.defaults))
    defaults = missing + list(a.defaults)
    add(Parameter.POSITIONAL_ONLY, a.posonlyargs, defaults)
    add(Parameter.POSITIONAL_OR_KEYWORD, a.args, defaults[len(a.posonlyargs) :])
    add(Parameter.VAR_POSITIONAL, [a.vararg] if a.vararg else [], [None])
    add(Parameter.KEYWORD_ONLY, a.kwonlyargs, a.kw_defaults)
    add(Parameter.VAR_KEYWORD, [a.kwarg] if a.kwarg else [], [None])
    return found


def _signature(function: Any) -> Signature:
    """The first overload, which has the defaults, with the annotations of all."""
    definitions = _definitions(function)
    annotations: Dict[str, List[Any]] = {}
    for definition in definitions:
        for parameter in _parameters(definition):
            if parameter.annotation is not Parameter.empty:
                annotations.setdefault(parameter.name, []).append(ast.parse(parameter.annotation, mode="eval").body)
    parameters = [p.replace(annotation=_any_of(annotations.get(p.name, []))) for p in _parameters(definitions[0])]
    return Signature(parameters, return_annotation=_any_of([definition.returns for definition in definitions]))


def _without_self(method: Any) -> Signature:
    found = _signature(method)
    return found.replace(parameters=list(found.parameters.values())[1:])


class _OfClass:
    """A class is called as its __init__ is, without self; what is called of an object is another function."""

    def __get__(self, thing: Any, kind: Any) -> Signature:
        if thing is not None:
            raise AttributeError("__signature__")
        return _without_self(kind.__init__).replace(return_annotation=kind.__name__)


def install() -> None:
    """For all functions and methods. Their types, phrame's own (NB_DOMAIN in CMakeLists.txt), take no new attributes,
    so that what they have is put where it is kept, of which the collector of garbage knows."""
    a_method: Any = _phrame.Polynomial.derivative
    modified: Any = getattr(_phrame, "_modified")
    for kind, signature in (
        (type(_phrame.integrate), _signature),
        (type(a_method), _signature),
        (type(_phrame.Polynomial([1]).derivative), _without_self),
    ):
        for kept in gc.get_referents(kind.__dict__):
            if isinstance(kept, dict):
                kept["__signature__"] = property(signature)
        modified(kind)
    types: List[Any] = [kind for kind in vars(_phrame).values() if isinstance(kind, type)]
    for kind in types:
        if isinstance(kind.__init__, type(a_method)):
            setattr(kind, "__signature__", _OfClass())
