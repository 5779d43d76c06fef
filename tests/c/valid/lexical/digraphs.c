/* Digraphs are alternative spellings of brackets, braces and the number sign (C17 6.4.6). */
%:include <stdio.h>
%:define JOIN(a, b) a %:%: b
%:define TEXT(a) %:a

int main(void)
<%
    int a<:3:> = <% 1, 2, 3 %>, JOIN(na, me) = 4;

    for (int i = 0; i < 3; i++)
        printf("%d ", a<:i:>);
    printf("%d %s %s\n", name, TEXT(<:), "<: stays in strings");
    return 0;
%>
