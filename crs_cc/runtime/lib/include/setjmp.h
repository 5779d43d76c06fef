/* Nonlocal jumps (C17 7.13). */
#ifndef _SETJMP_H
#define _SETJMP_H

struct __crs_jump {
    unsigned activation;     /* the call of a function that called setjmp; 0 for none */
    unsigned place;          /* where it goes on */
    int automatic;           /* how many local arrays it had got memory for */
    unsigned long unblocked; /* the signals that siglongjmp lets through; 0 to change none */
};

typedef struct __crs_jump jmp_buf[1];
typedef struct __crs_jump sigjmp_buf[1];

/* The compiler's: it goes on in the middle of the calling function. */
#define setjmp(buffer) __crs_setjmp(buffer)
#define _setjmp(buffer) __crs_setjmp(buffer)
#define sigsetjmp(buffer, save) __crs_sigsetjmp(buffer, (save) ? __crs_unblocked() : 0)

unsigned long __crs_unblocked(void);
_Noreturn void longjmp(jmp_buf buffer, int value);
_Noreturn void _longjmp(jmp_buf buffer, int value);
_Noreturn void siglongjmp(sigjmp_buf buffer, int value);

#endif
