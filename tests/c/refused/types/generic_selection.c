/* _Generic takes the association that fits; there must be one, and only one. */
int main(void)
{
    double d = 1;
    int a = _Generic(d, int: 1, char *: 2); // error: controlling expression type 'double' not compatible with any association
    int b = _Generic(d, double: 1, double: 2); // error: type 'double' in generic association compatible with previous type 'double'
    int c = _Generic(d, default: 1, default: 2); // error: duplicate default generic association
    return a + b + c;
}
