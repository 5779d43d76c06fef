/* Bytes that are no text in any encoding that C knows. */
int main(void)
{
    int größe = 1; // error: 
    return 0;
}
