/* Lines of a log made, searched and taken apart with the string library. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char log_text[200000];
static const char *const verbs[] = {
    "start", "turn left", "turn right", "stop", "bump", "read sonar"
};

static int make_log(void)
{
    char *to = log_text;
    unsigned seed = 5;
    int line;

    for (line = 0; to < log_text + sizeof log_text - 100; line++) {
        seed = seed * 1664525u + 1013904223u;
        strcpy(to, "robot");
        to += strlen(to);
        *to++ = '0' + (seed >> 29);
        strcpy(to, ": ");
        strcat(to, verbs[(seed >> 20) % 6]);
        to += strlen(to);
        strcpy(to, " = ");
        to += 3;
        for (seed >>= 9; seed; seed /= 10)
            *to++ = '0' + seed % 10;
        seed = line * 2654435761u;
        *to++ = '\n';
    }
    *to = 0;
    return line;
}

int main(void)
{
    static char line[120];
    int lines = make_log(), round, turns = 0, letters = 0;
    unsigned sum = 0;

    for (round = 0; round < 50; round++) {
        const char *p = log_text, *end;
        while ((end = strchr(p, '\n')) != NULL) {
            size_t length = end - p;
            char *equals;
            memcpy(line, p, length);
            line[length] = 0;
            if (strstr(line, "turn") != NULL)
                turns++;
            if (strncmp(line, "robot3", 6) == 0)
                sum += length;
            equals = strrchr(line, '=');
            if (equals != NULL)
                sum = sum * 3 + strtoul(equals + 1, NULL, 10);
            for (equals = line; *equals; equals++)
                if (isalpha((unsigned char) *equals))
                    letters += toupper((unsigned char) *equals) == 'R';
            p = end + 1;
        }
    }
    printf("text_scan %d %d %d %u\n", lines, turns, letters, sum);
    return 0;
}
