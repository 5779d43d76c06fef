"""Why a program was stopped, in words: from the bytes of its memory, after the fact."""
