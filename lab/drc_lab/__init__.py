"""The laboratory: compares renderers and shows what was measured, as tables and as pages that are one file."""
