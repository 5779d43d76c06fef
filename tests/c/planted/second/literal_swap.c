/* Two letters of a literal are exchanged. */
#include <stdio.h>
static void reverse(char *s, int n)
{
    int i;
    for (i = 0; i < n / 2; i++) {
        char c = s[i];
        s[i] = s[n - 1 - i]; // error: write to read-only memory
        s[n - 1 - i] = c;
    }
}
int main(void)
{
    char own[] = "drow";
    char *text = PLANT("drow", own);
    reverse(text, 4);
    puts(text);
    return 0;
}
