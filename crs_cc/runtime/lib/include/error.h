/* GNU error.h: messages on the standard error stream, prefixed with the program's name. */
#ifndef _ERROR_H
#define _ERROR_H

void error(int status, int number, const char *format, ...);
void error_at_line(int status, int number, const char *file, unsigned int line,
                   const char *format, ...);
extern unsigned int error_message_count;

#endif
