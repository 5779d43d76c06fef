/* Shadow memory operations of the allocator, see crs_cc/ir/instruction.py. For the library itself:
   all are intrinsics of the compiler, and do nothing in unchecked builds. */
#ifndef CRS_SHADOW_H
#define CRS_SHADOW_H

#define CRS_INACCESSIBLE 0
#define CRS_WITHOUT_VALUE 3

/* Sets the state of some bytes; the state is a constant. */
void __crs_mark(void *address, unsigned int size, int state);

/* Makes some bytes accessible, but without value; `origin` is the first number that __crs_callers
   writes for their allocation. */
void __crs_mark_unset(void *address, unsigned int size, int origin);

/* Writes the numbers of the calls that led here, the innermost first; the count is a constant. */
void __crs_callers(int *sites, int count);

/* Returns the state of a byte; in unchecked builds every byte is inaccessible. */
int __crs_state(const void *address);

#endif
