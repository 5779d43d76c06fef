/* Regular expressions: what matches where, and what is an error. */
#include <regex.h>
#include <stdio.h>
static void t(const char *pattern, int cflags, const char *text, int eflags)
{
    regex_t re;
    regmatch_t m[4];
    char message[80];
    int error = regcomp(&re, pattern, cflags), i;

    printf("%s %d %s: ", pattern, cflags, text);
    if (error) {
        regerror(error, &re, message, sizeof message);
        printf("error %d %s\n", error, message);
        return;
    }
    error = regexec(&re, text, 4, m, eflags);
    printf("%d %d", (int)re.re_nsub, error);
    for (i = 0; !error && i < 4 && !(cflags & REG_NOSUB); i++)
        printf(" %d,%d", (int)m[i].rm_so, (int)m[i].rm_eo);
    puts("");
    regfree(&re);
}
int main(void)
{
    t("abc", 0, "xxabcabc", 0);
    t("a*b", 0, "caaab", 0);
    t("^a.c$", 0, "abc", 0);
    t("^a", 0, "ba", 0);
    t("^a", 0, "a", REG_NOTBOL);
    t("(a|ab)(c|bcd)(d*)", REG_EXTENDED, "abcd", 0);
    t("\\(a\\)\\(b\\)*", 0, "abb", 0);
    t("(ab)+", REG_EXTENDED, "zababab", 0);
    t("x?y", REG_EXTENDED, "xxy", 0);
    t("[0-9]{2,3}", REG_EXTENDED, "a1 22 4444", 0);
    t("[[:alpha:]_][[:alnum:]_]*", 0, "12 var_3=4", 0);
    t("[^]x-z]", 0, "]xyza", 0);
    t("HELLO", REG_ICASE, "say hello", 0);
    t("a$", REG_NEWLINE, "a\nb", 0);
    t("^b", REG_NEWLINE | REG_EXTENDED, "a\nb", 0);
    t("a.b", REG_NEWLINE, "a\nb", 0);
    t("\\(.\\)\\1", 0, "abccd", 0);
    t("foo|bar|", REG_EXTENDED, "xbar", 0);
    t("(a*)*", REG_EXTENDED, "aaab", 0);
    t("(a|b)*abb", REG_EXTENDED, "ababbabb", 0);
    t("a\\{2\\}", 0, "caaa", 0);
    t("*a", 0, "x*a", 0);
    t("a|*b", REG_EXTENDED | REG_NOSUB, "b", 0);
    t("(a", REG_EXTENDED, "a", 0);
    t("[a", REG_EXTENDED, "a", 0);
    t("a{3,2}", REG_EXTENDED, "a", 0);
    t("a\\", 0, "a", 0);
    t("\\(a\\)\\2", 0, "a", 0);
    t("[z-a]", 0, "a", 0);
    t("[[:nope:]]", 0, "a", 0);
    t("^([a-z]+) *= *([0-9.]+)$", REG_EXTENDED, "speed = 12.5", 0);
    t("(a*)*", REG_EXTENDED, "b", 0);
    t("(a*)+b", REG_EXTENDED, "xaab", 0);
    t("", REG_EXTENDED, "abc", 0);
    t("c$d", 0, "c$d", 0);
    t("a^b", 0, "a^b", 0);
    return 0;
}
