"""The examples of docs/python.md do what the page says."""
import doctest
import re

import pytest

from conftest import ROOT

PAGE = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")


def test_the_examples_of_the_page_print_what_it_says(tmp_path, monkeypatch):
    monkeypatch.chdir(ROOT)
    blocks = re.findall(r"```pycon\n(.*?)```", PAGE, re.DOTALL)
    assert len(blocks) >= 5
    text = "\n".join(blocks).replace("build/", f"{tmp_path}/")
    test = doctest.DocTestParser().get_doctest(text, {}, "docs/python.md", None, 0)
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    report = []
    runner.run(test, out=report.append)
    assert runner.failures == 0, "".join(report)


def test_every_name_of_the_package_stands_on_the_page():
    quadmatch = pytest.importorskip("quadmatch")
    for name in quadmatch.__all__:
        assert f"`{name}" in PAGE or f"quadmatch.{name}" in PAGE, name
