"""Diagnosis of run-time errors: explain a failure from the memory of the stopped program."""
