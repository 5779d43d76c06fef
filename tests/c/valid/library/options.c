/* getopt and getopt_long: what they give, and in which order the arguments end. */
#define _GNU_SOURCE
#include <getopt.h>
#include <stdio.h>
#include <string.h>

static int flag;

static void parse(const char *letters, const struct option *options, const char *line)
{
    static char copy[200];
    char *arguments[20], *rest;
    int count = 1, c, i, index;

    strcpy(copy, line);
    arguments[0] = "program";
    for (rest = strtok(copy, " "); rest != NULL; rest = strtok(NULL, " "))
        arguments[count++] = rest;
    arguments[count] = NULL;
    optind = 0;
    opterr = 0;
    printf("%s %s:", letters, line);
    for (;;) {
        index = -1;
        c = options == NULL ? getopt(count, arguments, letters)
                            : getopt_long(count, arguments, letters, options, &index);
        if (c == -1)
            break;
        printf(" %d", c);
        if (c > 31)
            printf("'%c'", c);
        if (optarg != NULL)
            printf("=%s", optarg);
        if (index >= 0)
            printf("[%d]", index);
        if (c == '?' || c == ':')
            printf("(%d)", optopt);
    }
    printf(" |");
    for (i = optind; i < count; i++)
        printf(" %s", arguments[i]);
    printf("\n");
}

int main(void)
{
    static const struct option options[] = {
        {"verbose", no_argument, NULL, 'v'},   {"speed", required_argument, NULL, 's'},
        {"level", optional_argument, NULL, 2}, {"quiet", no_argument, &flag, 7},
        {"version", no_argument, NULL, 'V'},   {NULL, 0, NULL, 0},
    };

    parse("ab:c::", NULL, "-a -b x file");
    parse("ab:c::", NULL, "-abx -c -cy z");
    parse("ab:c::", NULL, "one -a two -b three four -- -a five");
    parse("+ab:", NULL, "-a one -b two");
    parse("-ab:", NULL, "one -a two -b three four");
    parse("ab:", NULL, "-x -a -b");
    parse(":ab:", NULL, "-x -b");
    parse("ab", NULL, "-ax -");
    parse("ab", NULL, "");
    parse("vs:", options, "--verbose --speed=5 --speed 6 file --level --level=3 x");
    parse("vs:", options, "--quiet --qui --vers --ver --speed");
    parse(":vs:", options, "--speed");
    parse("vs:", options, "--verbose=1 --none -v -s7 -- --verbose");
    printf("%d\n", flag);
    return 0;
}
