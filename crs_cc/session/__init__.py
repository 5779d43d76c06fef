"""The run: compiles programs, and lets programs and environment take turns."""
