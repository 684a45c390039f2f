"""evaluate-page: makes a page of what `drc evaluate --json --pictures FOLDER` says."""

from __future__ import annotations

from pathlib import Path

from .arguments import Parser
from .evaluation import read_evaluation
from .files import check_writable, write_whole
from .requirements import require_modules


def _parser() -> Parser:
    parser = Parser(
        "drc_lab evaluate-page",
        usage="python3 -m drc_lab evaluate-page REPORT.json -o PAGE.html [--pictures FOLDER]",
        description="Make a page of an evaluation; drc evaluate --html does all of it",
        epilog="Example: drc evaluate examples --json --pictures out >out/report.json && "
        "python3 -m drc_lab evaluate-page out/report.json -o page.html",
    )
    parser.add_argument("report", metavar="REPORT.json", help="What drc evaluate --json printed")
    parser.add_argument("-o", "--output", metavar="PAGE.html", required=True, help="The page to write")
    parser.add_argument("--pictures", metavar="FOLDER", help="The pictures' folder. Default: that of the report")
    return parser


def evaluate_page(words: list[str]) -> int:
    """The exit status."""
    options = _parser().parse(words)
    require_modules()
    report, output = Path(options.report), Path(options.output)
    check_writable("-o", output)
    evaluation = read_evaluation(report)
    from .evaluation_page import evaluation_page  # imports matplotlib, which takes a second

    write_whole(output, evaluation_page(evaluation, Path(options.pictures or report.parent)))
    return 0
