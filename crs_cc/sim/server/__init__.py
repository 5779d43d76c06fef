"""What a program asks of the simulator itself, the vendor's server, and not of its robot."""
