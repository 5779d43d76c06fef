/* Variable arguments before C89: f(va_alist) va_dcl { va_list list; va_start(list); ... } */
#ifndef _VARARGS_H
#define _VARARGS_H

typedef __builtin_va_list va_list;

#undef va_start
#undef va_arg
#undef va_end

#define va_alist __va_alist
#define va_dcl int __va_alist;
#define va_start(list) __builtin_va_start(list, 0)
#define va_arg(list, type) __builtin_va_arg(list, type)
#define va_end(list) __builtin_va_end(list)

#endif
