"""Requests to the vendor's simulator itself rather than to the robot."""
