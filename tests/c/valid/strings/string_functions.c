/* string.h: copying, comparing, searching, splitting. */
#include <stdio.h>
#include <string.h>

static int sign(int n) { return (n > 0) - (n < 0); }

int main(void)
{
    char a[40], b[40], *p;
    const char *text = "the wheel of the robot";

    strcpy(a, "left");
    strcat(a, " and ");
    strncat(a, "right wheels", 5);
    printf("%s %d\n", a, (int) strlen(a));
    memset(b, '-', sizeof b);
    strncpy(b, "abc", 6);
    printf("%s %d %c\n", b, b[5], b[6]);
    strncpy(b, "abcdef", 3);
    printf("%.6s %d %c\n", b, b[3], b[7]);
    printf("%d %d %d %d\n", sign(strcmp("a", "b")), sign(strcmp("b", "a")), strcmp("x", "x"),
           sign(strcmp("abc", "abcd")));
    printf("%d %d\n", strncmp("abcx", "abcy", 3), sign(strncmp("abcx", "abcy", 4)));
    printf("%d\n", sign(strcmp("\xff", "a")));
    printf("%d %d\n", (int) (strchr(text, 'w') - text), strchr(text, 'z') == NULL);
    printf("%d %d\n", (int) (strrchr(text, 't') - text), (int) (strchr(text, 0) - text));
    printf("%s|%s\n", strstr(text, "of"), strstr(text, "") == text ? "all" : "none");
    printf("%d\n", strstr(text, "robots") == NULL);
    printf("%d %d\n", (int) strspn("112233abc", "123"), (int) strcspn("abc,def", ",;"));
    printf("%s\n", strpbrk(text, "xyzf"));
    strcpy(a, "vm 100,200;  st");
    for (p = strtok(a, " ,;"); p; p = strtok(NULL, " ,;"))
        printf("[%s]", p);
    printf("\n");
    memcpy(b, "0123456789", 11);
    memmove(b + 2, b, 6);
    printf("%s\n", b);
    memmove(b, b + 2, 6);
    printf("%s\n", b);
    printf("%d %d\n", memcmp("ab\0c", "ab\0c", 4), sign(memcmp("ab\0c", "ab\0d", 4)));
    printf("%s\n", (char *) memchr("find me", 'm', 7));
    return 0;
}
