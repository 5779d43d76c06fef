/* Options of the command line (POSIX getopt, GNU getopt_long). As in GNU's, operands are moved
   after the options, unless the option letters begin with '+'. */
#include <getopt.h>
#include <stdio.h>
#include <string.h>

char *optarg;
int optind = 1, opterr = 1, optopt = '?';

static char *rest;       /* remaining letters of an argument such as -abc */
static int skipped;      /* arguments without dash between optind and the next one to look at */

/* The constants of one call. */
struct call {
    int count;
    char **arguments;
    const char *letters;
    const struct option *options;    /* null for getopt */
    int *index;
    int says;                        /* 1 to complain on the standard error stream */
    int silent;                      /* result for a missing argument: ':' or '?' */
};

/* Moves the argument after the skipped ones to the front, and returns it. */
static char *take(struct call *call)
{
    char **front = call->arguments + optind, *taken = front[skipped];
    int i;

    for (i = skipped; i > 0; i--)
        front[i] = front[i - 1];
    front[0] = taken;
    optind++;
    return taken;
}

static int more(struct call *call)
{
    return optind + skipped < call->count && call->arguments[optind + skipped] != NULL;
}

static int bad(struct call *call, int letter, const char *what)
{
    optopt = letter;
    if (call->says)
        fprintf(stderr, "%s: %s -- '%c'\n", call->arguments[0], what, letter);
    return '?';
}

static int short_option(struct call *call)
{
    int letter = (unsigned char)*rest++;
    const char *found = letter == ':' || letter == ';' ? NULL : strchr(call->letters, letter);

    if (found == NULL) {
        bad(call, letter, "invalid option");
        if (*rest == 0)
            rest = NULL;
        return '?';
    }
    if (found[1] == ':') {
        optarg = *rest ? rest : NULL;
        rest = NULL;
        if (optarg == NULL && found[2] != ':') {
            if (!more(call)) {
                bad(call, letter, "option requires an argument");
                return call->silent;
            }
            optarg = take(call);
        }
    } else if (*rest == 0) {
        rest = NULL;
    }
    return letter;
}

static int complain(struct call *call, int value, const char *before, const char *name,
                    int size, const char *after)
{
    optopt = value;
    if (call->says)
        fprintf(stderr, "%s: %s'%.*s'%s\n", call->arguments[0], before, size, name, after);
    return '?';
}

/* Finds a long option by its name or the beginning of it; returns -1 for none, -2 for several. */
static int find_long(const struct option *options, const char *name, size_t size)
{
    int i, found = -1;

    for (i = 0; options[i].name != NULL; i++) {
        if (strncmp(options[i].name, name, size) != 0)
            continue;
        if (options[i].name[size] == 0)
            return i;
        if (found >= 0 && (options[i].has_arg != options[found].has_arg ||
                           options[i].flag != options[found].flag ||
                           options[i].val != options[found].val))
            found = -2;
        else if (found == -1)
            found = i;
    }
    return found;
}

/* Parses --name, --name=value; `argument` is the whole, `name` its part after the dashes. */
static int long_option(struct call *call, const char *argument, char *name)
{
    size_t size = strcspn(name, "=");
    int found = find_long(call->options, name, size), shown = name + size - argument;
    const struct option *option = call->options + found;

    if (found == -2)
        return complain(call, 0, "option ", argument, strlen(argument), " is ambiguous");
    if (found < 0)
        return complain(call, 0, "unrecognized option ", argument, strlen(argument), "");
    if (name[size] == '=') {
        if (option->has_arg == no_argument)
            return complain(call, option->val, "option ", argument, shown,
                            " doesn't allow an argument");
        optarg = name + size + 1;
    } else if (option->has_arg == required_argument) {
        if (!more(call)) {
            complain(call, option->val, "option ", argument, shown, " requires an argument");
            return call->silent;
        }
        optarg = take(call);
    }
    if (call->index != NULL)
        *call->index = found;
    if (option->flag == NULL)
        return option->val;
    *option->flag = option->val;
    return 0;
}

static int get(int count, char *const *arguments, const char *letters,
               const struct option *options, int *index, int only)
{
    struct call call = {count, (char **)arguments, letters, options, index, opterr, '?'};
    int in_order = *letters == '+';
    char *argument;

    if (*call.letters == '+' || *call.letters == '-')
        call.letters++;
    if (*call.letters == ':') {
        call.says = 0;
        call.silent = ':';
    }
    if (optind == 0) {
        optind = 1;
        rest = NULL;
    }
    optarg = NULL;
    if (rest != NULL)
        return short_option(&call);

    skipped = 0;
    while (more(&call)) {
        argument = call.arguments[optind + skipped];
        if (*argument == '-' && argument[1] != 0)
            break;
        if (in_order)
            return -1;
        if (*letters == '-') {
            optarg = take(&call);
            return 1;
        }
        skipped++;
    }
    if (!more(&call))
        return -1;
    argument = take(&call);
    if (strcmp(argument, "--") == 0)
        return -1;
    if (options != NULL && argument[1] == '-')
        return long_option(&call, argument, argument + 2);
    if (only && (argument[2] != 0 || strchr(call.letters, argument[1]) == NULL) &&
        find_long(options, argument + 1, strcspn(argument + 1, "=")) != -1)
        return long_option(&call, argument, argument + 1);
    rest = argument + 1;
    return short_option(&call);
}

int getopt(int count, char *const arguments[], const char *letters)
{
    return get(count, arguments, letters, NULL, NULL, 0);
}

int getopt_long(int count, char *const arguments[], const char *letters,
                const struct option *options, int *index)
{
    return get(count, arguments, letters, options, index, 0);
}

int getopt_long_only(int count, char *const arguments[], const char *letters,
                     const struct option *options, int *index)
{
    return get(count, arguments, letters, options, index, 1);
}
