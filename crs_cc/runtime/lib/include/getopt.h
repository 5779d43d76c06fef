/* POSIX getopt and GNU getopt_long: command-line options. */
#ifndef _GETOPT_H
#define _GETOPT_H

extern char *optarg;
extern int optind, opterr, optopt;

struct option {
    const char *name;
    int has_arg;
    int *flag;
    int val;
};

#define no_argument 0
#define required_argument 1
#define optional_argument 2

int getopt(int count, char *const arguments[], const char *letters);
int getopt_long(int count, char *const arguments[], const char *letters,
                const struct option *options, int *index);
int getopt_long_only(int count, char *const arguments[], const char *letters,
                     const struct option *options, int *index);

#endif
