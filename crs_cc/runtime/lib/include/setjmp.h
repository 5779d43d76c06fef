/* Nonlocal jumps (C17 7.13). */
#ifndef _SETJMP_H
#define _SETJMP_H

struct __crs_jump {
    unsigned activation;     /* the call of a function that called setjmp; 0 for none */
    unsigned place;          /* its resume point */
    int automatic;           /* number of its variable-length arrays */
    unsigned long unblocked; /* signal mask restored by siglongjmp; 0 to leave it */
};

typedef struct __crs_jump jmp_buf[1];
typedef struct __crs_jump sigjmp_buf[1];

/* Compiler intrinsic: it resumes in the middle of the calling function. */
#define setjmp(buffer) __crs_setjmp(buffer)
#define _setjmp(buffer) __crs_setjmp(buffer)
#define sigsetjmp(buffer, save) __crs_sigsetjmp(buffer, (save) ? __crs_unblocked() : 0)

unsigned long __crs_unblocked(void);
_Noreturn void longjmp(jmp_buf buffer, int value);
_Noreturn void _longjmp(jmp_buf buffer, int value);
_Noreturn void siglongjmp(sigjmp_buf buffer, int value);

#endif
