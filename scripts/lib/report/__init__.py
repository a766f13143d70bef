"""The report of run time against error: what scripts/report runs after building."""
