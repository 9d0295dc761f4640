"""Straight-line programs, recorded by tracing ordinary arithmetic."""
