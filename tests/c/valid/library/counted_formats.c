/* %n in all sizes, numbered arguments and odd sets of scanf, the result of puts. */
#include <stdio.h>

static void t(const char *format, const char *text)
{
    char found[300] = "";
    int result = sscanf(text, format, found);

    printf("%s %d %s\n", format, result, found);
}

int main(void)
{
    char b[20]="";
    int n=-1,a=0,c=0;
    signed char hh=-1;
    short h=-1;
    long long ll=-1;
    long l=-1;
    printf("%d\n", sscanf("ab-zq", "%[a-b-z]%n", b, &n));
    puts(b);
    printf("%d\n", sscanf("3 4", "%2$d %1$d", &a, &c));
    printf("%d %d\n", a, c);
    printf("%d\n", puts("hello"));
    printf("abc%n de%hhn f%hn g%lln h%ln\n", &n, &hh, &h, &ll, &l);
    printf("%d %d %d %lld %ld\n", n, hh, h, ll, l);
    printf("%d\n", sscanf("x12yz", "%*[x]%2$d%1$[yz]", b, &a));
    printf("%s %d\n", b, a);
    n = -1;
    c = snprintf(b, 3, "hello%n!", &n);
    printf("%d %d %s\n", c, n, b);
    n = 7;
    printf("%d", sscanf("12 zz", "%d%hhn", &a, &hh));
    printf(" %d %d\n", a, hh);
    sscanf("%[", "%%%[]a-[]", b);
    puts(b);
    t("%[a-b-z]","ab-z");
    t("%[a-b-z]","cmz-");
    t("%[-z]","-zab[^_x");
    t("%[^-z]","ab-z");
    t("%[z-a]","z-abc");
    t("%[a-]","a-b");
    t("%[]a]","]ab");
    t("%[^]a]","xy]");
    t("%[a-c-]","b-cd");
    t("%[--0]","-./01");
    t("%[+--]","+,-.");
    t("%[^-]","ab-");
    t("%[a-c-e]", "abcde-");
    return 0;
}
