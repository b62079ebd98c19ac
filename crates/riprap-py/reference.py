"""The reference page of the Python package, from the docstrings of its sources: prints docs/src/python-reference.md."""

import ast
import inspect
from pathlib import Path

SOURCES = Path(__file__).parent / "python/riprap"
HEAD = """# Python reference

Made from the docstrings of the package; do not edit, run `RIPRAP_WRITE_DOCS=1 cargo test -p riprap-cli --test all docs`. How to
use it: [Python](python.md).
"""


def exports() -> list[tuple[str, str]]:
    """Module and name of everything that ``import riprap`` offers, in the order of ``__init__.py``."""
    tree = ast.parse((SOURCES / "__init__.py").read_text(encoding="utf-8"))
    froms = [node for node in tree.body if isinstance(node, ast.ImportFrom) and node.module]
    return [(node.module, alias.name) for node in froms for alias in node.names]


def module(name: str) -> ast.Module:
    stub = SOURCES / f"{name}.pyi"
    path = stub if stub.exists() else SOURCES / f"{name}.py"
    return ast.parse(path.read_text(encoding="utf-8"))


def text(node: ast.AST) -> str:
    """A docstring as Markdown: roles become code, the list of arguments a list."""
    said = inspect.cleandoc(ast.get_docstring(node) or "")
    for role in ("class", "meth", "func", "attr", "exc"):
        said = said.replace(f":{role}:`", "`")
    out, verbatim, arguments = [], False, False
    for line in said.replace("``", "`").splitlines():
        indented = line.startswith("    ")
        if line.endswith("::"):
            line = line[:-1]
            verbatim = True
        elif verbatim and not indented and line:
            verbatim = False
        if line.rstrip() in ("Args:", "Raises:", "Returns:", "Yields:"):
            arguments = True
            out += ["", line.strip(), ""]
        elif arguments and indented and not verbatim:
            deeper = line.startswith("        ")
            out.append(f"  {line.strip()}" if deeper else f"- {line.strip()}")
        else:
            arguments = arguments and not line
            out.append(line)
    return "\n".join(out).strip()


def signature(node: ast.FunctionDef, bound: bool) -> str:
    arguments = ast.unparse(node.args)
    if bound:
        arguments = arguments.removeprefix("self").removeprefix("cls").removeprefix(", ")
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    return f"{node.name}({arguments}){returns}"


def has(node: ast.FunctionDef, decorator: str) -> bool:
    return any(isinstance(d, ast.Name) and d.id == decorator for d in node.decorator_list)


def function(node: ast.FunctionDef, prefix: str, level: str) -> list[str]:
    return [f"{level} `{prefix}{node.name}`", f"```python\n{signature(node, bound=False)}\n```", text(node)]


def members(node: ast.ClassDef) -> list[str]:
    """Attributes with their docstrings, properties and methods."""
    rows, methods = [], []
    for here, after in zip(node.body, [*node.body[1:], None]):
        if isinstance(here, ast.AnnAssign) and isinstance(here.target, ast.Name) and not here.target.id.startswith("_"):
            said = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant) and str(after.value.value)
            rows.append(f"- `{here.target.id}: {ast.unparse(here.annotation)}`" + (f": {said}" if said else ""))
        if not isinstance(here, ast.FunctionDef) or not ast.get_docstring(here) or here.name.startswith("_"):
            continue
        if has(here, "property"):
            returns = f": {ast.unparse(here.returns)}" if here.returns else ""
            rows.append(f"- `{here.name}{returns}`: {text(here)}")
        else:
            methods += [f"#### `{node.name}.{here.name}`", f"```python\n{signature(here, bound=True)}\n```", text(here)]
    return (["\n".join(rows)] if rows else []) + methods


def page() -> str:
    parts = [HEAD]
    functions, classes, errors = [], [], []
    for name, item in exports():
        for node in module(name).body:
            if getattr(node, "name", None) != item:
                continue
            if isinstance(node, ast.FunctionDef):
                functions += function(node, "riprap.", "###")
            elif isinstance(node, ast.ClassDef):
                made = [f"### `riprap.{item}`", text(node), *members(node)]
                (errors if name == "errors" else classes).extend(made)
    parts += ["## Functions", *functions, "## Classes", *classes]
    shapes = module("shapes")
    parts += ["## `riprap.shapes`", text(shapes)]
    for node in shapes.body:
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            parts += function(node, "riprap.shapes.", "###")
    parts += ["## Exceptions", *errors]
    whole = "\n\n".join(part.strip() for part in parts if part.strip())
    while "\n\n\n" in whole:
        whole = whole.replace("\n\n\n", "\n\n")
    return whole + "\n"


if __name__ == "__main__":
    print(page(), end="")
