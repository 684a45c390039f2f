"""`drc bench`: compares renderers and writes what was found as a table, as JSON and as a page."""

from __future__ import annotations

import sys

from . import log
from .bench import run_bench
from .bench_options import DEFAULT_SECONDS, bench_parser, bench_settings
from .errors import Error
from .files import check_writable, make_folder, write_whole
from .interrupt import Cancel
from .requirements import require_modules
from .result_json import report_json
from .table import markdown


def bench(words: list[str]) -> int:
    """The exit status."""
    options = bench_parser().parse(words)
    log.set_level(log.QUIET if options.quiet else log.VERBOSE if options.verbose else log.NORMAL)
    settings = bench_settings(options)
    require_modules()  # before hours of rendering rather than after them
    if not (options.seconds or options.spp or options.tasks):
        log.info(f"no budget is given: {DEFAULT_SECONDS} s for each render; --seconds, --spp and --tasks set others")
    make_folder(settings.output)
    table_file, data_file, page_file = (settings.output / name for name in ("bench.md", "bench.json", "index.html"))
    for file in (table_file, data_file, page_file):
        check_writable("-o", file)
    cancel = Cancel()
    cancel.install()
    report = run_bench(settings, cancel)
    table = markdown(report)
    sys.stdout.write(table)
    sys.stdout.flush()
    write_whole(data_file, report_json(report))
    write_whole(table_file, table)
    from .page import bench_page  # imports matplotlib, which takes a second

    write_whole(page_file, bench_page(report, settings.output, settings.own.path))
    failures = [run.failure for run in report.runs if run.failure]
    if cancel.cancelled:
        log.info("interrupted; called again in the same way, it goes on")
    log.info(f"{page_file}: {len(report.runs)} runs, {len(failures)} failed")
    if failures and len(failures) == len(report.runs):
        raise Error(f"all runs failed; the first: {failures[0]}")
    return 128 + cancel.signal if cancel.cancelled else 0
